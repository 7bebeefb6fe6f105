// Extraction of members of zip archives.
// Used by read_xml.cpp.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace csgsim::solids {

inline constexpr std::size_t max_unzipped_bytes = std::size_t{1} << 28U;

bool is_zip(std::string_view bytes);

/// Extracts a member of a zip archive; an empty `member_name` selects the first member. Throws InputError with the
/// archive's name if there is no such member, if it is damaged, or if it is larger than
/// `max_unzipped_bytes`.
std::string unzip(std::string_view archive, std::string_view archive_name, const std::string& member_name);

}  // namespace csgsim::solids
