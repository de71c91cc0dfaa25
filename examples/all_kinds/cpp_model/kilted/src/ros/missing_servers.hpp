// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

#ifndef ROS__MISSING_SERVERS_HPP_
#define ROS__MISSING_SERVERS_HPP_

#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "rclcpp/create_timer.hpp"
#include "rclcpp/logging.hpp"

#include "managed_node.hpp"
#include "stop.hpp"

namespace all_kinds
{

/// Warns about servers that are not available, at most every ten seconds.
class MissingServers
{
public:
  /// Watch the server of a client.
  template<typename Client>
  void watch(const std::string & name, const std::shared_ptr<Client> & client)
  {
    servers_.emplace_back(name, [client] {return client->is_ready();});
  }

  void start(ManagedNode & node)
  {
    timer_ = rclcpp::create_wall_timer(
      timeouts::MISSING,
      [logger = node.get_logger(), servers = servers_, due = node.missing_due()] {
        const auto missing = names(servers);
        if (!missing.empty() && Stop::Clock::now() >= *due) {
          *due = Stop::Clock::now() + timeouts::QUIET;
          RCLCPP_WARN(logger, "Waiting for %s.", missing.c_str());
        }
      },
      nullptr,
      node.get_node_base_interface().get(),
      node.get_node_timers_interface().get());
  }

  void stop() {timer_.reset();}

private:
  using Servers = std::vector<std::pair<std::string, std::function<bool ()>>>;

  static std::string names(const Servers & servers)
  {
    std::string names;
    for (const auto & [name, is_ready] : servers) {
      if (!is_ready()) {
        names += (names.empty() ? "" : ", ") + name;
      }
    }
    return names;
  }

  Servers servers_;
  rclcpp::TimerBase::SharedPtr timer_;
};

}  // namespace all_kinds

#endif  // ROS__MISSING_SERVERS_HPP_
