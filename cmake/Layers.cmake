# SPDX-License-Identifier: MIT
# ombrage_layer(NAME [EXTRA_SOURCES ...] [EXCLUDE files...] DEPENDS targets...): a static library of src/NAME. Files that end in _test.cpp
# beside the sources belong to the layer's test program (tests/CMakeLists.txt).
set(OMBRAGE_GPU_LAYERS gl render lab)

function(ombrage_layer name)
  cmake_parse_arguments(ARG "" "" "EXTRA_SOURCES;EXCLUDE;DEPENDS" ${ARGN})
  file(GLOB sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/src/${name}/*.cpp)
  foreach(file IN LISTS ARG_EXCLUDE)
    list(REMOVE_ITEM sources ${PROJECT_SOURCE_DIR}/src/${name}/${file})
  endforeach()
  set(tests ${sources})
  list(FILTER sources EXCLUDE REGEX "_test\\.cpp$")
  list(FILTER tests INCLUDE REGEX "_test\\.cpp$")
  set_property(GLOBAL PROPERTY OMBRAGE_TESTS_${name} ${tests})
  add_library(ombrage_${name} STATIC ${sources} ${ARG_EXTRA_SOURCES})
  target_include_directories(ombrage_${name} PUBLIC ${PROJECT_SOURCE_DIR}/include PRIVATE ${PROJECT_SOURCE_DIR}/src)
  target_compile_features(ombrage_${name} PUBLIC cxx_std_20)
  target_link_libraries(ombrage_${name} PUBLIC ${ARG_DEPENDS} Threads::Threads PRIVATE ombrage_warnings)
  # glm's gtx headers ask for this.
  target_compile_definitions(ombrage_${name} PUBLIC GLM_ENABLE_EXPERIMENTAL PRIVATE OMBRAGE_VERSION="${PROJECT_VERSION}")
  if(OMBRAGE_SANITIZE AND NOT name IN_LIST OMBRAGE_GPU_LAYERS)
    target_compile_options(ombrage_${name} PUBLIC -fsanitize=${OMBRAGE_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer)
    target_link_options(ombrage_${name} PUBLIC -fsanitize=${OMBRAGE_SANITIZE})
  endif()
endfunction()
