#!/bin/sh
# Install the Debian packages that the tests need, if this user may; say in a line what is done.
cd "$(dirname "$0")"
missing=
while read -r package; do
  dpkg -s "$package" >/dev/null 2>&1 || missing="$missing $package"
done <debian-packages.txt
[ -n "$missing" ] || exit 0
skip() {
  echo "Not installed ($1):$missing. Tests in ROS 1 and of C++ that need them will skip."
  exit 0
}
command -v apt-get >/dev/null || skip "there is no apt-get here"
sudo=
if [ "$(id -u)" != 0 ]; then
  sudo="sudo -n"
  $sudo true 2>/dev/null || skip "this needs root, or sudo without a password"
fi
echo "Installing with apt-get, for ROS 1 and C++:$missing"
export DEBIAN_FRONTEND=noninteractive
$sudo apt-get update -qq || skip "apt-get update failed"
# shellcheck disable=SC2086
$sudo apt-get install -qq --no-install-recommends $missing >/dev/null || skip "apt-get failed"
