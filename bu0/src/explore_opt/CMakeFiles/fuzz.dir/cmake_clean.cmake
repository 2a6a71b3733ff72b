file(REMOVE_RECURSE
  "CMakeFiles/fuzz"
)

# Per-language clean rules from dependency scanning.
foreach(lang )
  include(CMakeFiles/fuzz.dir/cmake_clean_${lang}.cmake OPTIONAL)
endforeach()
