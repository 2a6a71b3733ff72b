
# Per-language clean rules from dependency scanning.
foreach(lang )
  include(CMakeFiles/rotors_comm_gencpp.dir/cmake_clean_${lang}.cmake OPTIONAL)
endforeach()
