# SPDX-License-Identifier: MIT
# ombrage_embed_shaders(TARGET): generates kEmbeddedShaders from every GLSL file of src/render/glsl ("ombrage/FILE"),
# src/techniques/shared ("shared/FILE") and the technique folders ("FAMILY/NAME/FILE").
function(ombrage_embed_shaders target)
  file(GLOB shaders CONFIGURE_DEPENDS
       ${PROJECT_SOURCE_DIR}/src/render/glsl/*.* ${PROJECT_SOURCE_DIR}/src/techniques/shared/*.glsl
       ${PROJECT_SOURCE_DIR}/src/techniques/shared/*.vert ${PROJECT_SOURCE_DIR}/src/techniques/shared/*.frag
       ${PROJECT_SOURCE_DIR}/src/techniques/shared/*.geom ${PROJECT_SOURCE_DIR}/src/techniques/shared/*.comp
       ${PROJECT_SOURCE_DIR}/src/techniques/shared/*.tesc ${PROJECT_SOURCE_DIR}/src/techniques/shared/*.tese
       ${PROJECT_SOURCE_DIR}/src/techniques/*/*/*.glsl ${PROJECT_SOURCE_DIR}/src/techniques/*/*/*.vert
       ${PROJECT_SOURCE_DIR}/src/techniques/*/*/*.frag ${PROJECT_SOURCE_DIR}/src/techniques/*/*/*.geom
       ${PROJECT_SOURCE_DIR}/src/techniques/*/*/*.comp)
  set(output ${PROJECT_BINARY_DIR}/generated/embedded_shaders.cpp)
  set(list ${PROJECT_BINARY_DIR}/generated/embedded_shaders.txt)
  list(JOIN shaders "\n" lines)
  file(CONFIGURE OUTPUT ${list} CONTENT "${lines}\n" @ONLY)
  add_custom_command(OUTPUT ${output}
    COMMAND ${CMAKE_COMMAND} -DLIST=${list} -DROOT=${PROJECT_SOURCE_DIR}/src -DOUTPUT=${output}
            -P ${PROJECT_SOURCE_DIR}/cmake/EmbedShadersScript.cmake
    DEPENDS ${shaders} ${list} ${PROJECT_SOURCE_DIR}/cmake/EmbedShadersScript.cmake
    COMMENT "Embedding shaders" VERBATIM)
  target_sources(${target} PRIVATE ${output})
endfunction()
