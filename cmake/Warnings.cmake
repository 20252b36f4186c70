# SPDX-License-Identifier: MIT
# Strict from the first commit; warnings are errors in our own code.
add_library(ombrage_warnings INTERFACE)
target_compile_options(ombrage_warnings INTERFACE -Wall -Wextra -Wshadow -Wnon-virtual-dtor -Woverloaded-virtual -Wcast-align
                       -Wunused -Wpedantic -Wno-missing-field-initializers -Werror)
