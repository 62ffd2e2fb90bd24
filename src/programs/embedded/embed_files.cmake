# Makes a header of the files in a folder, and of others: their names and contents.
function(synthetic_dataset_embed_files header folder)
  file(GLOB files CONFIGURE_DEPENDS ${folder}/*.html ${folder}/*.js ${folder}/*.css ${folder}/*.svg)
  list(APPEND files ${ARGN})
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${files})
  string(CONCAT text
    "#pragma once\n\n// Made by CMake from the files that the programs have within them.\n\n#include <string_view>\n\n"
    "namespace synthetic_dataset::programs {\n\n"
    "// With it the compiler need not count the letters, of which clang counts no more than a million.\n"
    "using std::string_view_literals::operator\"\"sv;\n\n"
    "struct EmbeddedFile {\n  std::string_view name;\n  std::string_view content;\n};\n\n"
    "// The first is no file: there has to be one.\n"
    "inline constexpr EmbeddedFile kEmbeddedFiles[] = {\n    {\"\", \"\"},\n")
  foreach(file ${files})
    get_filename_component(name ${file} NAME)
    file(READ ${file} content)
    string(APPEND text "    {\"${name}\", R\"page(${content})page\"sv},\n")
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
