// What the numerical checks find, for make targets and for machines without GoogleTest.
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <string>

#include "faults/fault.hpp"
#include "hash/compare.hpp"
#include "hash/tracks.hpp"
#include "stiff/page.hpp"

namespace {

int usage() {
  std::cerr
      << "usage: echoway_verify stiff [PART]   run the stiff cases whose title holds PART; exit 1 when one fails\n"
         "       echoway_verify stiff-page     print docs/stiff-cases.md\n"
         "       echoway_verify faults-page    print docs/faults.md\n"
         "       echoway_verify hash [N]       print the hashes of the fixed walks, computed by N threads\n"
         "       echoway_verify tracks         print every estimate of the fixed walks\n"
         "       echoway_verify compare A B M  exit 1 when two such outputs are more than M metres apart\n";
  return 2;
}

int compare(const char* first, const char* second, double bound_m) {
  std::ifstream a(first);
  std::ifstream b(second);
  const echoway::tracks::Difference d = echoway::tracks::compare(a, b);
  std::printf("%zu estimates, %zu in another room, at most %.3g m and %.3g rad apart (allowed %.3g m)\n", d.rows,
              d.rooms, d.position_m, d.heading_rad, bound_m);
  return d.comparable && d.rooms == 0 && d.position_m <= bound_m ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  const std::string command = argc > 1 ? argv[1] : "";
  if (command == "stiff") return echoway::stiff::report_failures(argc > 2 ? argv[2] : "") == 0 ? 0 : 1;
  if (command == "stiff-page") {
    std::cout << echoway::stiff::page();
    return 0;
  }
  if (command == "faults-page") {
    std::cout << echoway::faults::page();
    return 0;
  }
  if (command == "hash") {
    std::cout << echoway::tracks::hashes(echoway::tracks::run(argc > 2 ? std::atoi(argv[2]) : 1));
    return 0;
  }
  if (command == "tracks") {
    std::cout << echoway::tracks::rows(echoway::tracks::run(1));
    return 0;
  }
  if (command == "compare" && argc == 5) return compare(argv[2], argv[3], std::strtod(argv[4], nullptr));
  return usage();
}
