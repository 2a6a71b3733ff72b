# Empty custom commands generated dependencies file for std_srvs_generate_messages_py.
# This may be replaced when dependencies are built.
