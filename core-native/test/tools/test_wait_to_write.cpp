// `echoway play` waits for a listener: what wakes it early.
#include "tools/wait_to_write.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <pthread.h>
#include <signal.h>
#include <unistd.h>

#include <array>
#include <thread>

namespace echoway::tools {
namespace {

using namespace std::chrono_literals;

/// A line that is full.
class FullPipe {
 public:
  FullPipe() {
    EXPECT_EQ(pipe2(ends_.data(), O_CLOEXEC | O_NONBLOCK), 0);
    const std::array<char, 4096> bytes{};
    while (::write(ends_[1], bytes.data(), bytes.size()) > 0) {
    }
  }
  FullPipe(const FullPipe&) = delete;
  FullPipe& operator=(const FullPipe&) = delete;
  ~FullPipe() {
    ::close(ends_[0]);
    ::close(ends_[1]);
  }
  void drain() const {
    std::array<char, 4096> bytes{};
    while (::read(ends_[0], bytes.data(), bytes.size()) > 0) {
    }
  }
  [[nodiscard]] int into() const { return ends_[1]; }

 private:
  std::array<int, 2> ends_{-1, -1};
};

/// For as long as it lives, the signal interrupts what waits instead of being ignored.
class Interrupting {
 public:
  explicit Interrupting(int signal) : signal_(signal) {
    struct sigaction action {};
    action.sa_handler = [](int) {};
    sigaction(signal_, &action, &before_);
  }
  Interrupting(const Interrupting&) = delete;
  Interrupting& operator=(const Interrupting&) = delete;
  ~Interrupting() { sigaction(signal_, &before_, nullptr); }

 private:
  int signal_;
  struct sigaction before_ {};
};

TEST(WaitToWrite, AWindowThatChangesItsSizeIsNoListenerWhoIsGone) {
  const FullPipe line;
  const Interrupting resized(SIGWINCH);
  const pthread_t waits = pthread_self();
  std::thread others([&] {
    for (int i = 0; i < 20; ++i) {
      std::this_thread::sleep_for(10ms);
      pthread_kill(waits, SIGWINCH);
    }
    line.drain();
  });
  EXPECT_TRUE(wait_to_write(line.into(), 60s));
  others.join();
}

TEST(WaitToWrite, GivesUpWhenNobodyReads) {
  const FullPipe line;
  EXPECT_FALSE(wait_to_write(line.into(), 1ms));
}

}  // namespace
}  // namespace echoway::tools
