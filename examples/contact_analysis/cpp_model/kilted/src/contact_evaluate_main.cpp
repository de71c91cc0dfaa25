// Copyright 2019 My Company
// SPDX-License-Identifier: GPL-3.0-only

// The executable of the node contact_evaluate.

namespace contact_analysis
{

int run_contact_evaluate(int argc, char ** argv);

}  // namespace contact_analysis

int main(int argc, char ** argv)
{
  return contact_analysis::run_contact_evaluate(argc, argv);
}
