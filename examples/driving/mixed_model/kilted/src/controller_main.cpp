// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

// The executable of the node controller.

namespace driving
{

int run_controller(int argc, char ** argv);

}  // namespace driving

int main(int argc, char ** argv)
{
  return driving::run_controller(argc, argv);
}
