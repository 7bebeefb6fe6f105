#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace csgsim::solids {

inline constexpr std::size_t most_unzipped_bytes = std::size_t{1} << 28U;

bool is_zip(std::string_view bytes);

/// A part of a zip archive; its first one if the part's name is empty. Throws InputError, with the archive's name, if
/// there is no such part, if it is damaged, or longer than `most_unzipped_bytes`.
std::string unzip(std::string_view archive, std::string_view name, const std::string& part);

}  // namespace csgsim::solids
