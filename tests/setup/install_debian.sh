#!/bin/sh
# Install Debian's ROS 1 packages unless they are there, if this user may.
packages=$(cat "$(dirname "$0")/debian-packages.txt")
# shellcheck disable=SC2086
dpkg -s $packages >/dev/null 2>&1 && exit 0
command -v apt-get >/dev/null || { echo "No apt-get here: the ROS 1 tests will skip."; exit 0; }
sudo=
[ "$(id -u)" = 0 ] || sudo="sudo -n"
export DEBIAN_FRONTEND=noninteractive
# shellcheck disable=SC2086
$sudo apt-get update -q && $sudo apt-get install -q -y --no-install-recommends $packages && exit 0
echo "Could not install Debian's ROS 1 packages: the ROS 1 tests will skip."
