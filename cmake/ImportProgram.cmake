# SPDX-License-Identifier: MIT
# ombrage-import, the process that reads files under guard. It lies beside the program.
function(ombrage_import_program)
  add_executable(ombrage_import ${PROJECT_SOURCE_DIR}/src/scene/import_main.cpp)
  set_target_properties(ombrage_import PROPERTIES OUTPUT_NAME ombrage-import RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/bin)
  target_include_directories(ombrage_import PRIVATE ${PROJECT_SOURCE_DIR}/src)
  target_link_libraries(ombrage_import PRIVATE ombrage_scene ombrage_warnings)
endfunction()
