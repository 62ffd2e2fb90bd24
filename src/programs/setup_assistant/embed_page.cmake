# Makes a header of the files of the set-up page, and others: their names and contents.
function(synthetic_dataset_embed_page header folder)
  file(GLOB files CONFIGURE_DEPENDS ${folder}/*.html ${folder}/*.js ${folder}/*.css ${folder}/*.svg)
  list(APPEND files ${ARGN})
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${files})
  string(CONCAT text
    "#pragma once\n\n// Made by CMake from the files of the page.\n\n#include <string_view>\n\n"
    "namespace synthetic_dataset::programs {\n\n"
    "struct EmbeddedFile {\n  std::string_view name;\n  std::string_view content;\n};\n\n"
    "// The first one is not a file: there has to be one.\n"
    "inline constexpr EmbeddedFile kEmbeddedPage[] = {\n    {\"\", \"\"},\n")
  foreach(file ${files})
    get_filename_component(name ${file} NAME)
    file(READ ${file} content)
    string(APPEND text "    {\"${name}\", R\"page(${content})page\"},\n")
  endforeach()
  string(APPEND text "};\n\n}  // namespace synthetic_dataset::programs\n")
  set(earlier "")
  if(EXISTS ${header})
    file(READ ${header} earlier)
  endif()
  if(NOT text STREQUAL earlier)
    file(WRITE ${header} "${text}")
  endif()
endfunction()
