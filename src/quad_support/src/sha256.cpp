#include "quad_support/sha256.hpp"

#include <sha2.h>
#include <sys/types.h>

#include <cstdint>

namespace quad_support {

std::string sha256(std::string_view bytes) {
  char text[SHA256_DIGEST_STRING_LENGTH];
  SHA256Data(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size(), text);
  return text;
}

}  // namespace quad_support
