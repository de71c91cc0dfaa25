// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

#ifndef ALL_KINDS__ROS__SERVICE_CLIENT_HPP_
#define ALL_KINDS__ROS__SERVICE_CLIENT_HPP_

#include <chrono>
#include <optional>

namespace all_kinds
{

/// Calls a service. This base class, for tests without ROS, finds no server.
template<typename Service>
class ServiceClient
{
public:
  using Request = typename Service::Request;
  using Response = typename Service::Response;
  using Seconds = std::chrono::duration<double>;

  virtual ~ServiceClient() = default;

  /// Return whether a server is available.
  virtual bool is_ready() {return false;}

  /// Return the response, or nothing: after the timeout, in wall time, or when the node stops.
  std::optional<Response> call(
    const Request & request,
    Seconds timeout = std::chrono::seconds(1))
  {
    return wait_for_response(request, timeout);
  }

protected:
  virtual std::optional<Response> wait_for_response(
    const Request & /* request */,
    Seconds /* timeout */)
  {
    return std::nullopt;
  }
};

}  // namespace all_kinds

#endif  // ALL_KINDS__ROS__SERVICE_CLIENT_HPP_
