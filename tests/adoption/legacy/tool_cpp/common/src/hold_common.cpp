#include "ros/ros.h"

/* protected region user include files begin */
#include <cmath>
/* protected region user include files end */

class HoldImpl
{
    /* protected region user member variables begin */
    bool is_closed_ = false;
    /* protected region user member variables end */

public:
    void configure(HoldConfig config)
    {
        /* protected region user configure begin */
        is_closed_ = std::abs(config.force) < 0.1;
        /* protected region user configure end */
    }
    bool callback_grip(std_srvs::Trigger::Request  &req, std_srvs::Trigger::Response &res , HoldConfig config)
    {
        /* protected region user implementation of service callback for grip begin */
        is_closed_ = true;
        res.success = is_closed_;
        /* protected region user implementation of service callback for grip end */
        return true;
    }
    /* protected region user additional functions begin */
    /* protected region user additional functions end */
};
