// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

// The executable of the node sensor.

namespace driver
{

int run_sensor(int argc, char ** argv);

}  // namespace driver

int main(int argc, char ** argv)
{
  return driver::run_sensor(argc, argv);
}
