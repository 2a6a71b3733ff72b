# CMAKE generated file: DO NOT EDIT!
# Timestamp file for custom commands dependencies management for download_extra_data.
