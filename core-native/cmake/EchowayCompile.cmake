# Compile options that every target of the project shares.
#
# Floating-point contraction is off and no fast-math is ever given, so that debug and release, GCC and Clang, x86-64 and
# AArch64 round every operation alike.
function(echoway_compile_options target)
  target_compile_features(${target} PUBLIC cxx_std_20)
  set_target_properties(${target} PROPERTIES CXX_EXTENSIONS OFF)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion
                                           -Wnon-virtual-dtor -Wno-missing-field-initializers -Werror)
  # GCC 12 sees an overlap in `"literal" + std::string` where there is none (GCC bug 105329).
  target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>)
  target_compile_options(${target} PUBLIC -ffp-contract=off -fno-math-errno)
  # Packing the two coordinates of a point into one register costs more than it saves: what was stored as two numbers and is
  # read as one must wait for the memory (a firing took 7 % longer).
  target_compile_options(${target} PRIVATE -fno-tree-slp-vectorize)
endfunction()

# For a target that calls the core and computes next to nothing itself: to optimise it as the core is takes a quarter of the
# time that it takes to compile, and gains none. Rounding is the same.
function(echoway_compile_quickly target)
  target_compile_options(${target} PRIVATE $<$<CONFIG:RelWithDebInfo>:-O1>)
endfunction()
