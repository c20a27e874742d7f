// Prints what the numerical checks find: `stiff` and `hash` are pass or fail, `stiff-page` and `faults-page` write the
// documentation's tables, `tracks` writes every estimate for comparing two machines.
#include <cstdio>
#include <cstring>
#include <fstream>
#include <iostream>
#include <string>

#include "stiff/page.hpp"

namespace {

int usage() {
  std::cerr << "usage: echoway_verify stiff | stiff-page\n";
  return 2;
}

}  // namespace

int main(int argc, char** argv) {
  const std::string command = argc > 1 ? argv[1] : "";
  if (command == "stiff") return echoway::stiff::report_failures() == 0 ? 0 : 1;
  if (command == "stiff-page") {
    std::cout << echoway::stiff::page();
    return 0;
  }
  return usage();
}
