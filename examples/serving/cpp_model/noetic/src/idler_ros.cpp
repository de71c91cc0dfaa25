// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

// The node idler: its life-cycle and its ROS interfaces.
// Generated from serving.ros_package.
// The logic is in idler_impl.cpp.

#include <cstdint>
#include <exception>
#include <memory>

#include "ros/ros.h"
#include "ros_log.hpp"
#include "serving/idler_impl.hpp"
#include "serving/idler_interface.hpp"

namespace serving
{

/// A node that calls its logic back from its start to its end.
class IdlerNode
{
public:
  /// Read the parameters, create publishers and clients, and construct the logic.
  IdlerNode()
  {
    read_parameters();
    connect_senders();
  }

  IdlerNode(const IdlerNode &) = delete;
  IdlerNode & operator=(const IdlerNode &) = delete;

  /// Destroy subscriptions and servers, then clean up the logic.
  ~IdlerNode()
  {
    spinner_.stop();
    if (configured_) {
      impl_->cleanup();
    }
  }

  /// Configure the logic and serve until shutdown.
  bool run()
  {
    if (!impl_->configure(*config_)) {
      ROS_FATAL("The logic rejected its configuration.");
      return false;
    }
    configured_ = true;
    connect_receivers();
    spinner_.start();
    ros::waitForShutdown();
    return true;
  }

private:
  void read_parameters()
  {
    config_ = std::make_shared<IdlerConfig>();
  }

  /// Create publishers and clients, then the logic.
  void connect_senders()
  {
    IdlerPassthrough passthrough;
    passthrough.log = Logger(write_log);
    passthrough.now = [] {
        return Time(static_cast<std::int64_t>(ros::Time::now().toNSec()));
      };
    impl_ = std::make_unique<IdlerImpl>(passthrough);
  }

  /// Create subscriptions and servers; callbacks that may block get their own thread.
  void connect_receivers()
  {
    // Nothing of this node receives.
  }

  ros::NodeHandle node_;
  ros::NodeHandle private_{"~"};
  std::shared_ptr<const IdlerConfig> config_;
  std::unique_ptr<IdlerImpl> impl_;
  bool configured_ = false;
  ros::AsyncSpinner spinner_{1};
};

}  // namespace serving

int main(int argc, char ** argv)
{
  ros::init(argc, argv, "idler");
  serving::set_log_level();
  try {
    return serving::IdlerNode().run() ? 0 : 1;
  } catch (const std::exception & error) {
    ROS_FATAL("%s", error.what());
    return 1;
  }
}
