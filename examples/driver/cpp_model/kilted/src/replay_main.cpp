// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

// The executable of the node replay.

namespace driver
{

int run_replay(int argc, char ** argv);

}  // namespace driver

int main(int argc, char ** argv)
{
  return driver::run_replay(argc, argv);
}
