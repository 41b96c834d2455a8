# Sources that instantiate a kernel over Lanes (lib/uhas/runtime/lanes_detail.hpp).
include(CheckCXXCompilerFlag)
check_cxx_compiler_flag("-mavx2 -mfma" UHAS_COMPILER_HAS_AVX2)
if(UHAS_COMPILER_HAS_AVX2 AND CMAKE_SYSTEM_PROCESSOR MATCHES "^(x86_64|AMD64|amd64)$")
  set(UHAS_HAS_AVX2_SOURCES ON)
endif()

# uhas_kernel_sources(<target> <name>): adds <name>_baseline.cpp to the target and, where the compiler has AVX2, <name>_avx2.cpp
# too, which alone is compiled for it. Always optimised, whatever the build type: a helper that is not inlined there would be
# a weak symbol with wide instructions in it, which the linker might give to any caller.
function(uhas_kernel_sources target name)
  set(flags -O2 -fno-exceptions -fno-math-errno -ffp-contract=fast)
  set(baseline ${CMAKE_CURRENT_SOURCE_DIR}/${name}_baseline.cpp)
  set(avx2 ${CMAKE_CURRENT_SOURCE_DIR}/${name}_avx2.cpp)
  target_sources(${target} PRIVATE ${baseline})
  set_property(SOURCE ${baseline} TARGET_DIRECTORY ${target} APPEND PROPERTY COMPILE_OPTIONS ${flags})
  if(UHAS_HAS_AVX2_SOURCES)
    target_sources(${target} PRIVATE ${avx2})
    set_property(SOURCE ${avx2} TARGET_DIRECTORY ${target} APPEND PROPERTY COMPILE_OPTIONS ${flags} -mavx2 -mfma)
  endif()
endfunction()
