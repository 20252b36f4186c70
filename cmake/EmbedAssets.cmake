# SPDX-License-Identifier: MIT
# ombrage_embed_assets(TARGET): the report's style sheets and scripts (src/report/assets) as kReportStyle and kReportScript. Each
# kind is one text in the order of its list, which src/report/assets/order.txt gives.
function(ombrage_embed_assets target)
  set(folder ${PROJECT_SOURCE_DIR}/src/report/assets)
  file(GLOB assets CONFIGURE_DEPENDS ${folder}/*.css ${folder}/*.js)
  set(output ${PROJECT_BINARY_DIR}/generated/report_assets.cpp)
  add_custom_command(OUTPUT ${output}
    COMMAND ${CMAKE_COMMAND} -DFOLDER=${folder} -DOUTPUT=${output} -P ${PROJECT_SOURCE_DIR}/cmake/EmbedAssetsScript.cmake
    DEPENDS ${assets} ${folder}/order.txt ${PROJECT_SOURCE_DIR}/cmake/EmbedAssetsScript.cmake
    COMMENT "Embedding the report's style and script" VERBATIM)
  target_sources(${target} PRIVATE ${output})
endfunction()
