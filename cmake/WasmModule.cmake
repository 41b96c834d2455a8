# C++ sources as a WebAssembly module, by a Clang that has the target wasm32-wasi and its libraries. Without one,
# UHAS_WASM_PROBLEM says so.
find_program(UHAS_WASM_CXX NAMES clang++-14 clang++ DOC "Clang that compiles for WebAssembly")

# Exceptions are thrown, not caught: the module says what a throw does. The stack lies first, so that its overflow is a trap.
set(UHAS_WASM_FLAGS --target=wasm32-wasi -std=c++20 -O2 -msimd128 -DNDEBUG -Xclang -fignore-exceptions)
set(UHAS_WASM_LINK_FLAGS --target=wasm32-wasi -mexec-model=reactor
  -Wl,--strip-all -Wl,--stack-first -Wl,-z,stack-size=262144)

if(NOT UHAS_WASM_WORKS)
  set(probe ${CMAKE_CURRENT_BINARY_DIR}/wasm_probe)
  file(WRITE ${probe}.cpp "#include <string>\nstd::string probe() { return std::to_string(1); }\n")
  set(status "no Clang found")
  if(UHAS_WASM_CXX)
    execute_process(COMMAND ${UHAS_WASM_CXX} ${UHAS_WASM_FLAGS} ${UHAS_WASM_LINK_FLAGS} ${probe}.cpp -o ${probe}.wasm
      RESULT_VARIABLE status ERROR_VARIABLE said)
  endif()
  if(status EQUAL 0)
    set(UHAS_WASM_WORKS ON CACHE INTERNAL "UHAS_WASM_CXX compiles and links")
  else()
    set(UHAS_WASM_PROBLEM "WebAssembly cannot be compiled here (${UHAS_WASM_CXX}: ${status}); install clang-14 lld-14 wasi-libc \
libc++-14-dev-wasm32 libc++abi-14-dev-wasm32 libclang-rt-14-dev-wasm32, or set UHAS_WASM_CXX to a clang++ with the target wasm32-wasi")
  endif()
endif()

# uhas_wasm_module(<file.wasm> <source>...): makes the module from these sources; paths without a folder are of the current one.
function(uhas_wasm_module module)
  set(objects)
  foreach(source ${ARGN})
    cmake_path(ABSOLUTE_PATH source NORMALIZE)
    cmake_path(GET source STEM stem)
    set(object ${module}.dir/${stem}.o)
    add_custom_command(OUTPUT ${object}
      COMMAND ${CMAKE_CXX_COMPILER_LAUNCHER} ${UHAS_WASM_CXX} ${UHAS_WASM_FLAGS} -I${PROJECT_SOURCE_DIR}/lib
        -MD -MF ${object}.d -c ${source} -o ${object}
      DEPENDS ${source} DEPFILE ${object}.d COMMENT "Compiling ${stem} for WebAssembly" VERBATIM)
    list(APPEND objects ${object})
  endforeach()
  file(MAKE_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR}/${module}.dir)
  add_custom_command(OUTPUT ${module}
    COMMAND ${UHAS_WASM_CXX} ${UHAS_WASM_LINK_FLAGS} ${objects} -o ${module}
    DEPENDS ${objects} COMMENT "Linking ${module}" VERBATIM)
endfunction()
