// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

// The logic of sensor. Edit this file.

#include "driver/sensor_impl.hpp"

namespace driver
{

SensorImpl::SensorImpl(
  const SensorPassthrough & passthrough)
: passthrough_(passthrough)
{
}

bool SensorImpl::configure(
  [[maybe_unused]] const SensorConfig & config)
{
  return true;
}

bool SensorImpl::activate()
{
  return true;
}

// Thread read
void SensorImpl::read()
{
  passthrough_.sleep(1.0);
}

void SensorImpl::deactivate()
{
}

void SensorImpl::cleanup()
{
}

}  // namespace driver
