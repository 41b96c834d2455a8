# Sources that instantiate a kernel over plain numbers or over Lanes (lib/uhas/runtime/lanes/lanes.hpp).
include(CheckCXXCompilerFlag)
check_cxx_compiler_flag("-mavx2 -mfma" UHAS_COMPILER_HAS_AVX2)
if(UHAS_COMPILER_HAS_AVX2 AND CMAKE_SYSTEM_PROCESSOR MATCHES "^(x86_64|AMD64|amd64)$")
  set(UHAS_HAS_AVX2_SOURCES ON)
endif()
check_cxx_compiler_flag("-mavx512f -mavx512vl -mavx512dq" UHAS_COMPILER_HAS_AVX512)
if(UHAS_HAS_AVX2_SOURCES AND UHAS_COMPILER_HAS_AVX512)
  set(UHAS_HAS_AVX512_SOURCES ON)
endif()

# Always optimised, whatever the build type: a helper that is not inlined in an AVX2 source would be a weak symbol with wide
# instructions in it, which the linker might give to any caller. GCC's joining of neighbouring scalars to vectors doubles the
# time of a solve (GCC 12, Zen 3: 7.5 against 3.6 us on the Shadow hand): vectors just written number by number are read whole.
# A solve raises no floating-point traps and looks at no zero's sign: saying so makes a select one instruction (5 % of a solve).
set(UHAS_KERNEL_FLAGS -O3 -fno-math-errno -fno-trapping-math -fno-signed-zeros -ffp-contract=fast)
if(CMAKE_CXX_COMPILER_ID STREQUAL GNU)
  list(APPEND UHAS_KERNEL_FLAGS -fno-tree-slp-vectorize)
endif()

# uhas_kernel_source(<target> <file> [<flag>...]): adds a source that is compiled with the flags above and these.
function(uhas_kernel_source target file)
  set(path ${CMAKE_CURRENT_SOURCE_DIR}/${file})
  target_sources(${target} PRIVATE ${path})
  set_property(SOURCE ${path} TARGET_DIRECTORY ${target} APPEND PROPERTY COMPILE_OPTIONS ${UHAS_KERNEL_FLAGS} ${ARGN})
endfunction()

# uhas_kernel_sources(<target> <name>): adds <name>_baseline.cpp and, where the compiler has AVX2, <name>_avx2.cpp, which alone
# is compiled for it.
function(uhas_kernel_sources target name)
  uhas_kernel_source(${target} ${name}_baseline.cpp -fno-exceptions)
  if(UHAS_HAS_AVX2_SOURCES)
    uhas_kernel_source(${target} ${name}_avx2.cpp -fno-exceptions -mavx2 -mfma)
  endif()
endfunction()

# uhas_same_bits_sources(<target> <name>): the same, and <name>_avx512.cpp where the compiler has AVX-512; none fuses a
# multiplication with an addition, so that lanes that do the same give the same bits.
function(uhas_same_bits_sources target name)
  uhas_kernel_source(${target} ${name}_baseline.cpp -fno-exceptions -ffp-contract=off)
  if(UHAS_HAS_AVX2_SOURCES)
    uhas_kernel_source(${target} ${name}_avx2.cpp -fno-exceptions -ffp-contract=off -mavx2)
  endif()
  if(UHAS_HAS_AVX512_SOURCES)
    uhas_kernel_source(${target} ${name}_avx512.cpp -fno-exceptions -ffp-contract=off
      -mavx2 -mavx512f -mavx512vl -mavx512dq)
  endif()
endfunction()
