// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

// The executable of the node observer.

namespace all_kinds
{

int run_observer(int argc, char ** argv);

}  // namespace all_kinds

int main(int argc, char ** argv)
{
  return all_kinds::run_observer(argc, argv);
}
