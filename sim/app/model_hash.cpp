#include "sim/app/model_hash.h"

#include <fstream>
#include <sstream>

#include "sim/study/hash.h"

namespace csgsim::app {

std::string hash_of_file(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::stringstream content;
  content << file.rdbuf();
  study::Hash hash;
  hash.add(content.str());
  return hash.text();
}

}  // namespace csgsim::app
