// File system functions missing in Debian's libc++ for WASI. A page has no files: none exists, and no name is a link.
#include <filesystem>
#include <fstream>
#include <system_error>

template class std::basic_filebuf<char>;
template class std::basic_ifstream<char>;

// NOLINTBEGIN(cert-dcl58-cpp,bugprone-reserved-identifier)
_LIBCPP_BEGIN_NAMESPACE_FILESYSTEM

path __absolute(const path& name, error_code* /*error*/) { return name; }

path __canonical(const path& name, error_code* /*error*/) { return name; }

path __read_symlink(const path& /*name*/, error_code* error) {
  if (error != nullptr) *error = make_error_code(errc::invalid_argument);
  return {};
}

file_status __status(const path& /*name*/, error_code* error) {
  if (error != nullptr) *error = make_error_code(errc::no_such_file_or_directory);
  return file_status(file_type::not_found);
}

_LIBCPP_END_NAMESPACE_FILESYSTEM
// NOLINTEND(cert-dcl58-cpp,bugprone-reserved-identifier)
