// Copyright Bench
// SPDX-License-Identifier: Apache-2.0

// The logic of server.

#include "bench/server_impl.hpp"

namespace bench
{

ServerImpl::ServerImpl(
  const ServerPassthrough & passthrough)
: passthrough_(passthrough)
{
}

bool ServerImpl::configure(
  [[maybe_unused]] const ServerConfig & config)
{
  return true;
}

bool ServerImpl::activate()
{
  return true;
}

// Topic values
void ServerImpl::receive_values(
  const server_types::ValuesMessage & message)
{
  record_.message(message.data.at(0));
}

// Service set
void ServerImpl::serve_set(
  const server_types::SetService::Request & request,
  server_types::SetService::Response & response)
{
  response.success = request.data;
}

// Action compute
void ServerImpl::execute_compute(
  Goal<server_types::ComputeAction> & goal)
{
  goal.result.sequence = {goal.request.order};
  goal.succeed();
}

void ServerImpl::deactivate()
{
  record_.save();
}

void ServerImpl::cleanup()
{
}

}  // namespace bench
