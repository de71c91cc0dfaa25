// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

// The logic of controller. Edit this file.

#include "driving/controller_impl.hpp"

namespace driving
{

ControllerImpl::ControllerImpl(
  const ControllerPassthrough & passthrough)
: passthrough_(passthrough)
{
}

bool ControllerImpl::configure(
  [[maybe_unused]] const ControllerConfig & config)
{
  return true;
}

bool ControllerImpl::activate()
{
  return true;
}

void ControllerImpl::update(
  [[maybe_unused]] ControllerData & data,
  [[maybe_unused]] const ControllerConfig & config)
{
}

// Service stop
void ControllerImpl::serve_stop(
  [[maybe_unused]] const controller_types::StopService::Request & request,
  [[maybe_unused]] controller_types::StopService::Response & response)
{
}

void ControllerImpl::deactivate()
{
}

void ControllerImpl::cleanup()
{
}

}  // namespace driving
