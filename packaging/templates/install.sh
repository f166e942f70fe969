#!/bin/sh
# Installs shaderlint and shaderport from the archive for this machine.
#
#   install.sh               into ~/.local/bin
#   install.sh --to FOLDER   into FOLDER
#   install.sh --force       replaces files that this script did not install
#
#   SHADERLINT_URL=URL       the folder with the archives and SHA256SUMS
set -eu

version="{{version}}"
url="${SHADERLINT_URL:-{{releases}}}"
# The oldest glibc 2 of the programs.
oldest_glibc="{{glibc_minor}}"

say() { printf '%s\n' "install.sh: $*" >&2; }
fail() {
    say "$@"
    exit 1
}
has() { command -v "$1" >/dev/null 2>&1; }

to=
force=
while [ $# -gt 0 ]; do
    case "$1" in
    --to)
        [ $# -gt 1 ] || fail "--to needs a folder"
        to="$2"
        shift
        ;;
    --force) force=1 ;;
    --help | -h)
        sed -n '2,/^set/s/^# \{0,1\}//p' "$0"
        exit
        ;;
    *) fail "unknown argument '$1'; see --help" ;;
    esac
    shift
done
[ -n "$to" ] || to="${HOME:?is not set; pass --to FOLDER}/.local/bin"

# The programs for musl are static, and run where glibc is too old or absent.
libc() {
    glibc="$(getconf GNU_LIBC_VERSION 2>/dev/null)" || glibc=
    minor="${glibc#glibc 2.}"
    case "$minor" in
    "" | *[!0-9]*) echo musl ;;
    *) if [ "$minor" -ge "$oldest_glibc" ]; then echo gnu; else echo musl; fi ;;
    esac
}

platform() {
    machine="$(uname -m)"
    case "$(uname -s)" in
    Linux) system="unknown-linux-$(libc)" ;;
    Darwin)
        system="apple-darwin"
        # A shell under Rosetta reports the processor that is emulated.
        [ "$(sysctl -n sysctl.proc_translated 2>/dev/null)" != 1 ] || machine=arm64
        ;;
    *) fail "there is no archive for $(uname -s); see {{repository}}" ;;
    esac
    case "$machine" in
    x86_64 | amd64) echo "x86_64-$system" ;;
    aarch64 | arm64) echo "aarch64-$system" ;;
    *) fail "there is no archive for $machine; see {{repository}}" ;;
    esac
}

download() {
    if has curl; then
        curl --fail --silent --show-error --location --output "$2" "$1"
    elif has wget; then
        wget --quiet --output-document="$2" "$1"
    else
        fail "needs curl or wget"
    fi || fail "cannot download $1"
}

checksum() {
    if has sha256sum; then
        sha256sum "$1"
    elif has shasum; then
        shasum -a 256 "$1"
    else
        fail "needs sha256sum or shasum"
    fi | cut -d ' ' -f 1
}

work="$(mktemp -d)"
trap 'rm -rf "$work"' EXIT
trap 'exit 1' HUP INT TERM

triple="$(platform)"
name="shaderlint-$version-$triple"
download "$url/SHA256SUMS" "$work/SHA256SUMS"
download "$url/$name.tar.gz" "$work/$name.tar.gz"
expected="$(sed -n "s/^\([0-9a-f]\{64\}\)  $name\.tar\.gz\$/\1/p" "$work/SHA256SUMS")"
[ -n "$expected" ] || fail "SHA256SUMS does not list $name.tar.gz"
[ "$(checksum "$work/$name.tar.gz")" = "$expected" ] || fail "the checksum of $name.tar.gz is wrong"
tar -xzf "$work/$name.tar.gz" -C "$work"

# What this script installed, so that it replaces nothing else.
receipt="${XDG_DATA_HOME:-${HOME:-$to}/.local/share}/shaderlint/installed"
mkdir -p "$to" "$(dirname "$receipt")"
to="$(cd "$to" && pwd)"
touch "$receipt"
for program in shaderlint shaderport; do
    file="$to/$program"
    if [ -d "$file" ]; then
        fail "$file is a folder"
    elif [ -e "$file" ] || [ -L "$file" ]; then
        if [ ! -L "$file" ] && grep -qxF "$(checksum "$file")  $file" "$receipt"; then
            continue
        fi
        [ -n "$force" ] || fail "$file exists and was not installed by this script; --force replaces it"
        say "replaces $file, which was not installed by this script"
    fi
done
for program in shaderlint shaderport; do
    file="$to/$program"
    # Never a partly written program.
    cp "$work/$name/$program" "$file.new$$"
    chmod 755 "$file.new$$"
    mv -f "$file.new$$" "$file"
    { grep -vF "  $file" "$receipt" || true; } >"$work/receipt"
    printf '%s  %s\n' "$(checksum "$file")" "$file" >>"$work/receipt"
    cp "$work/receipt" "$receipt"
done

say "installed shaderlint and shaderport $version into $to"
case ":$PATH:" in
*":$to:"*) ;;
*) say "add the folder to PATH: export PATH=\"$to:\$PATH\"" ;;
esac
