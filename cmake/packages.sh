# shellcheck shell=sh disable=SC2154
# Packages: what csgsim needs of this system, and how to install it. Read by setup.sh, in the folder of the sources.
# The columns of cmake/packages.txt are in the order of its rows of systems.

# packages MANAGER GROUP...: the packages of these groups on one line.
packages() {
  manager=$1
  shift
  awk -v manager="$manager" -v groups=" $* " '
    $1 == "system" { managers++; if ($2 == manager) column = managers + 2 }
    /^#|^system|^$/ || !index(groups, " " $1 " ") || $column == "-" { next }
    { gsub(",", " ", $column); line = line (line == "" ? "" : " ") $column }
    END { print line }
  ' cmake/packages.txt
}

as_root() {
  if [ "$(id -u)" -eq 0 ]; then
    "$@"
  elif command -v sudo >/dev/null; then
    sudo "$@"
  else
    echo "setup.sh: packages must be installed, but sudo is missing; run this as root once" >&2
    exit 1
  fi
}

# The package manager of this system, by its name in cmake/packages.txt; "none" if it is another one.
package_manager() {
  for one in apt-get:apt dnf:dnf pacman:pacman zypper:zypper apk:apk brew:brew; do
    if command -v "${one%:*}" >/dev/null; then
      echo "${one#*:}"
      return
    fi
  done
  echo none
}

# is_installed MANAGER PACKAGE
is_installed() {
  case "$1" in
    apt) dpkg-query -W -f='${db:Status-Status}\n' "$2" 2>/dev/null | grep -qx installed ;;
    dnf | zypper) rpm -q --whatprovides "$2" >/dev/null 2>&1 ;;
    pacman) pacman -T "$2" >/dev/null 2>&1 ;;
    apk) apk info -e "$2" >/dev/null 2>&1 ;;
    brew) brew list "$2" >/dev/null 2>&1 ;;
  esac
}

# equivalents MANAGER PACKAGE...: lines "+ PACKAGE..." with the manager's name of each package of Debian, or "- NEED" if
# none is known.
equivalents() {
  manager=$1
  shift
  awk -v manager="$manager" -v wanted="$*" '
    BEGIN { count = split(wanted, names, " ")
      for (i = 1; i <= count; i++) is_wanted[names[i]] = 1 }
    $1 == "system" { managers++; if ($2 == manager) column = managers + 2 }
    /^#|^system|^$/ { next }
    { parts = split($3, apt, ",")
      for (i = 1; i <= parts; i++) {
        if (!(apt[i] in is_wanted)) continue
        delete is_wanted[apt[i]]
        if (shown[$2]++) continue
        names_here = $column
        gsub(",", " ", names_here)
        if (column == 0 || $column == "-") print "- " $2
        else print "+ " names_here
      } }
    END { for (name in is_wanted) print "- " name " (name of Debian)" }
  ' cmake/packages.txt
}

# system_row MANAGER FIELD: a field of the manager's row in cmake/packages.txt.
system_row() {
  awk -v manager="$1" -v field="$2" '$1 == "system" && $2 == manager { gsub("_", " ", $field); print $field }' cmake/packages.txt
}

# Installs those of the named packages of Debian that are missing.
need_of_apt() {
  missing=""
  for package in "$@"; do
    is_installed apt "$package" || missing="$missing $package"
  done
  [ -z "$missing" ] && return
  as_root apt-get update -q
  unknown=""
  for package in $missing; do
    apt-cache show "$package" >/dev/null 2>&1 || unknown="$unknown $package"
  done
  if [ -n "$unknown" ]; then
    echo "setup.sh: the archives of this system lack:$unknown" >&2
    echo "csgsim is tested on $(system_row apt 4). Install what is missing in another way and repeat the command with" \
      "CSGSIM_SKIP_PACKAGES=1; docs/install.md lists what csgsim needs." >&2
    exit 1
  fi
  echo "installing:$missing"
  # shellcheck disable=SC2086
  as_root env DEBIAN_FRONTEND=noninteractive apt-get install -qy --no-install-recommends $missing
}

# explain_missing MANAGER PACKAGES NEEDS: names the command that installs the packages, and the needs without one.
explain_missing() {
  {
    if [ -n "$2" ]; then
      sudo="sudo "
      [ "$1" != brew ] || sudo=""
      echo "setup.sh: csgsim needs packages that are missing here. This command installs them:"
      echo "  $sudo$(system_row "$1" 5)$2"
    fi
    [ -z "$3" ] || echo "setup.sh: install these from their sources, since no package is known:${3%,}"
    echo "Then repeat the command; with CSGSIM_SKIP_PACKAGES=1, which omits this check, if they come from elsewhere."
    case "$(system_row "$1" 3)" in
      unsupported) echo "csgsim cannot run on $(system_row "$1" 4) itself, since $(system_row "$1" 6); use the Containerfile." ;;
      *) echo "csgsim is tested on $(system_row apt 4) only; docs/install.md has the packages of other systems." ;;
    esac
  } >&2
}

# need PACKAGE...: installs packages of Debian there. Elsewhere prints the command that installs their equivalents and
# ends, because the names are not tested.
need() {
  [ -z "${CSGSIM_SKIP_PACKAGES:-}" ] || return 0
  manager=$(package_manager)
  if [ "$manager" = apt ]; then
    need_of_apt "$@"
    return
  fi
  missing=""
  unknown=""
  for line in $(equivalents "$manager" "$@" | tr ' ' '~'); do
    names=$(echo "${line#??}" | tr '~' ' ')
    case "$line" in
      -*) unknown="$unknown $names," ;;
      *)
        for package in $names; do
          is_installed "$manager" "$package" || missing="$missing $package"
        done
        ;;
    esac
  done
  [ -n "$missing$unknown" ] || return 0
  explain_missing "$manager" "$missing" "$unknown"
  exit 1
}

# Prints the packages of the program; the needs without a known package go to the error output.
print_packages() {
  manager=${1:-$(package_manager)}
  case "$manager" in
    apt | dnf | pacman | zypper | apk | brew) ;;
    *)
      echo "setup.sh: no packages are known for '$manager'; name apt, dnf, pacman, zypper, apk or brew" >&2
      exit 2
      ;;
  esac
  # shellcheck disable=SC2086
  packages "$manager" $program_groups
  # shellcheck disable=SC2046,SC2086
  unknown=$(equivalents "$manager" $(packages apt $program_groups) | sed -n 's/^- //p' | tr '\n' ' ')
  [ -z "$unknown" ] || echo "setup.sh: no package is known for: $unknown" >&2
}
