
# Per-language clean rules from dependency scanning.
foreach(lang )
  include(CMakeFiles/rotors_comm_genlisp.dir/cmake_clean_${lang}.cmake OPTIONAL)
endforeach()
