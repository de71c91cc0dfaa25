// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

// The executable of the node clerk.

namespace serving
{

int run_clerk(int argc, char ** argv);

}  // namespace serving

int main(int argc, char ** argv)
{
  return serving::run_clerk(argc, argv);
}
