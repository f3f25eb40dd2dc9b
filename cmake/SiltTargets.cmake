# One target per folder. silt_add_library(sim) makes the library silt_sim of the folder it stands in,
# whose headers are included as "silt/sim/….h" by those, and only those, who link to it.
include(GNUInstallDirs)

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/bin)
set(CMAKE_LIBRARY_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/lib)
set(CMAKE_ARCHIVE_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/lib)
if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "" FORCE)
endif()

# Warnings, sanitizers and floating-point rules for silt's own code. No contraction into
# fused multiply-adds: the same source gives the same bits on every processor. g++ 12 sees overlapping
# copies in std::string's own operator+ (GCC bug 105651), hence -Wno-restrict.
function(silt_compile_options target)
  target_compile_options(${target} PRIVATE
    $<$<COMPILE_LANGUAGE:CXX>:-Wall -Wextra -Wpedantic -Wshadow -ffp-contract=off>
    $<$<COMPILE_LANG_AND_ID:CXX,GNU>:-Wno-restrict>
    $<$<AND:$<COMPILE_LANGUAGE:CXX>,$<BOOL:${SILT_WERROR}>>:-Werror>)
  if(SILT_SANITIZE)
    target_compile_options(${target} PRIVATE
      $<$<COMPILE_LANGUAGE:CXX>:-fsanitize=${SILT_SANITIZE} -fno-omit-frame-pointer>)
    target_link_options(${target} PUBLIC -fsanitize=${SILT_SANITIZE})
  endif()
endfunction()

# silt_precompile(TARGET HEADERS…): large headers of other libraries, which are a third of what most of
# the target's sources cost to compile. What comes from there g++ 12 no longer takes for a system's
# header, and then sees overflows in std::string's operator+ too (bug 105651, as above).
function(silt_precompile target)
  foreach(header ${ARGN})
    target_precompile_headers(${target} PRIVATE $<$<COMPILE_LANGUAGE:CXX>:<${header}$<ANGLE-R>>)
  endforeach()
  target_compile_options(${target} PRIVATE $<$<COMPILE_LANG_AND_ID:CXX,GNU>:
    -Wno-array-bounds -Wno-stringop-overflow -Wno-stringop-overread>)
endfunction()

# silt_add_library(NAME SOURCES … [PUBLIC libs…] [PRIVATE libs…]); NAME may hold a slash: core/io.
function(silt_add_library name)
  cmake_parse_arguments(ARG "" "" "SOURCES;PUBLIC;PRIVATE" ${ARGN})
  string(REPLACE "/" "_" suffix ${name})
  set(target silt_${suffix})
  set(root ${PROJECT_BINARY_DIR}/include/${suffix})
  get_filename_component(parent ${root}/silt/${name} DIRECTORY)
  file(MAKE_DIRECTORY ${parent})
  file(CREATE_LINK ${CMAKE_CURRENT_SOURCE_DIR} ${root}/silt/${name} SYMBOLIC)
  add_library(${target} STATIC ${ARG_SOURCES})
  add_library(silt::${suffix} ALIAS ${target})
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${suffix})
  target_include_directories(${target} PUBLIC
    $<BUILD_INTERFACE:${root}> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
  target_compile_features(${target} PUBLIC cxx_std_20)
  target_link_libraries(${target} PUBLIC ${ARG_PUBLIC} PRIVATE ${ARG_PRIVATE})
  silt_compile_options(${target})
  set_property(GLOBAL APPEND PROPERTY SILT_LIBRARIES ${target})
  file(GLOB headers CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.h)
  install(FILES ${headers} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/silt/${name})
endfunction()
