# SPDX-License-Identifier: MIT
# Strict from the first commit; warnings are errors in our own code.
add_library(ombrage_warnings INTERFACE)
target_compile_options(ombrage_warnings INTERFACE -Wall -Wextra -Wshadow -Wnon-virtual-dtor -Woverloaded-virtual -Wcast-align
                       -Wunused -Wpedantic -Wno-missing-field-initializers -Werror)
# GCC 12 sees overlaps in std::string's operator+ that are not there (GCC bug 105651).
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
  target_compile_options(ombrage_warnings INTERFACE -Wno-restrict)
endif()
