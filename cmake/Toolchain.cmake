# What every target is compiled with. Included once, from the top.
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
if(NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "" FORCE)
endif()

find_program(CCACHE ccache)
if(CCACHE)
  # Paths relative to the checkout, so that another clone of the same commit finds everything built.
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env CCACHE_BASEDIR=${CMAKE_SOURCE_DIR} CCACHE_NOHASHDIR=1 ${CCACHE})
endif()

# Same input, same plan, bit for bit, on every machine: no fused multiply-add behind our back (what libraries do: docs/install.md).
add_compile_options(-ffp-contract=off)
# Position-independent throughout, so that the Python module links the same rooms as the program; without interposition the code is as fast.
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
add_compile_options(-fno-semantic-interposition)
add_compile_options(-Wall -Wextra -Wpedantic -Wshadow -Wold-style-cast -Wnon-virtual-dtor -Werror)

option(STRANDLINE_ASAN "address and undefined-behaviour sanitizers, checked standard library" OFF)
if(STRANDLINE_ASAN)
  add_compile_options(-fsanitize=address,undefined -fno-sanitize-recover=undefined -fno-omit-frame-pointer)
  add_link_options(-fsanitize=address,undefined)
  add_compile_definitions(_GLIBCXX_ASSERTIONS)
  # g++ 12 sees uninitialized members in std::regex when it is instrumented; the plain builds keep the warning.
  add_compile_options(-Wno-maybe-uninitialized)
endif()

if(STRANDLINE_FUZZ)
  add_compile_options(-fsanitize=fuzzer-no-link,address,undefined -fno-sanitize-recover=undefined -fno-omit-frame-pointer)
  add_compile_options(-Wno-deprecated-declarations)  # libstdc++ 12 calls get_temporary_buffer in stable_sort
  add_link_options(-fsanitize=address,undefined)
  add_compile_definitions(_GLIBCXX_ASSERTIONS)
endif()
