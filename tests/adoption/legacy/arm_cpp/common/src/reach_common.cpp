/**
* @file reach_common.cpp
**/

#include "ros/ros.h"

/* protected region user include files begin */
#include <mutex>
#include "filter.hpp"
/* protected region user include files end */

class ReachImpl
{
    /* protected region user member variables begin */
    std::mutex mutex_;
    Filter filter_;
    bool moving_;
    /* protected region user member variables end */

public:
    ReachPassthrough passthrough;

    ReachImpl()
    {
        /* protected region user constructor begin */
        moving_ = true;
        /* protected region user constructor end */
    }
    ~ReachImpl()
    {
        /* protected region user destructor begin */
        moving_ = false;
        /* protected region user destructor end */
    }
    void configure(ReachConfig config)
    {
        /* protected region user configure begin */
        filter_.gain = config.gain;
        /* protected region user configure end */
    }
    void update(ReachData &data, ReachConfig config)
    {
        /* protected region user update begin */
        filter_.gain = config.gain;
        data.out_pose.data = filter_.step(moving_ ? 1.0 : 0.0);
        /* protected region user update end */
    }

    void callback_learn(const test_msgs::FibonacciGoalConstPtr &goal, actionlib::SimpleActionServer<test_msgs::FibonacciAction> *as_)
    {
        /* protected region user implementation of action callback for learn begin */
        ROS_INFO_STREAM("learning " << goal->order);
        as_->setSucceeded();
        /* protected region user implementation of action callback for learn end */
    }
    bool callback_load(std_srvs::Trigger::Request  &req, std_srvs::Trigger::Response &res , ReachConfig config)
    {
        /* protected region user implementation of service callback for load begin */
        res.success = moving_;
        return true;
        /* protected region user implementation of service callback for load end */
        return true;
    }
    void directTopicCallback_stop(const std_msgs::Empty::ConstPtr& msg)
    {
        /* protected region user implementation of direct subscriber callback for stop begin */
        stop();
        /* protected region user implementation of direct subscriber callback for stop end */
    }
    /* protected region user additional functions begin */
    void stop()
    {
        std::lock_guard<std::mutex> lock(mutex_);
        moving_ = false;
    }
    /* protected region user additional functions end */
};
