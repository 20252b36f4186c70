# SPDX-License-Identifier: MIT
# cmake -DLIST=file with one source a line -DOUTPUT=file.cpp -P: see SceneSources.cmake.
file(STRINGS ${LIST} sources)
set(digests "")
foreach(source IN LISTS sources)
  file(SHA256 ${source} digest)
  string(APPEND digests "${digest}")
endforeach()
string(SHA256 digest "${digests}")
file(WRITE ${OUTPUT} "namespace ombrage {\nextern const char* const kSceneSourcesDigest;\nconst char* const kSceneSourcesDigest = \"${digest}\";\n}  // namespace ombrage\n")
