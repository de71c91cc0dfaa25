// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

// The node idler: its lifecycle and its ROS interfaces.
// Generated from serving.ros_package.
// The logic is in idler_impl.cpp.

#include <cstdint>
#include <memory>
#include <string>

#include "ros/clock.hpp"
#include "ros/process.hpp"
#include "ros/ros.h"
#include "ros/ros_log.hpp"
#include "ros/supervisor.hpp"
#include "serving/idler_impl.hpp"
#include "serving/idler_interface.hpp"

namespace serving
{

/// The node and its life: configure, activate, serve until it stops, deactivate, cleanup.
class IdlerNode
{
public:
  /// Read the parameters, create publishers and clients, and construct the logic.
  explicit IdlerNode(Supervisor & supervisor)
  : supervisor_(supervisor)
  {
    read_parameters();
    connect_senders();
    spinner_.start();
  }

  IdlerNode(const IdlerNode &) = delete;
  IdlerNode & operator=(const IdlerNode &) = delete;

  ~IdlerNode()
  {
    spinner_.stop();
  }

  /// Go through the lifecycle, in the thread of the logic.
  void live()
  {
    if (!supervisor_.step("configure", [this] {return impl_->configure(*config_);})) {
      supervisor_.refuse("The logic refused to configure.");
      return;
    }
    supervisor_.set_state("inactive");
    const auto activate = [this] {return impl_->activate();};
    if (!supervisor_.stopping() && supervisor_.step("activate", activate)) {
      supervisor_.set_state("active");
      work();
      supervisor_.set_state("deactivating");
      supervisor_.waits().clear();
      supervisor_.step("deactivate", [this] {impl_->deactivate(); return true;});
    } else {
      supervisor_.refuse("The logic refused to activate.");
    }
    supervisor_.set_state("cleaning up");
    supervisor_.waits().clear();
    supervisor_.step("cleanup", [this] {impl_->cleanup(); return true;});
  }

  /// This node has no goals to abort.
  void abort_goals() {}

private:
  void read_parameters()
  {
    supervisor_.set_stop_timeout(private_.param("stop_timeout", 2.0));
    config_ = std::make_shared<IdlerConfig>();
  }

  /// Create publishers and clients, then the logic.
  void connect_senders()
  {
    IdlerPassthrough passthrough;
    passthrough.log = log_;
    passthrough.now = [] {
        return Time(static_cast<std::int64_t>(ros::Time::now().toNSec()));
      };
    passthrough.sleep = [this](double seconds) {return clock_.sleep(seconds);};
    impl_ = std::make_unique<IdlerImpl>(passthrough);
  }

  /// Receive and serve until the node stops.
  void work()
  {
    if (!supervisor_.stopping()) {
      supervisor_.guard("connect_receivers", [this] {connect_receivers();});
    }
    supervisor_.wait_for_stop();
  }

  /// Create subscriptions and servers; callbacks that may block get their own thread.
  void connect_receivers()
  {
    // Nothing of this node receives.
  }

  Supervisor & supervisor_;
  Logger log_{write_log};
  ros::NodeHandle node_;
  ros::NodeHandle private_{"~"};
  Clock clock_{node_, supervisor_.waits()};
  std::shared_ptr<const IdlerConfig> config_;
  std::unique_ptr<IdlerImpl> impl_;
  ros::AsyncSpinner spinner_{1};
};

}  // namespace serving

int main(int argc, char ** argv)
{
  return serving::run_node<serving::IdlerNode>(argc, argv, "idler");
}
