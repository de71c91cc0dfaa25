"""A package with logic, for the tests of updates."""

SPEC = """<package name="arm" author="Ada" author_email="ada@example.org" description="An arm"
         license="MIT">
  <node name="reach" frequency="10">
    <publisher name="pose" type="std_msgs::Float64"/>
    <subscriber name="goal" type="std_msgs::Float64"/>
    <directSubscriber name="stop" type="std_msgs::Empty"/>
    <serviceServer name="load" type="std_srvs::Trigger"/>
    <serviceServer name="store" type="std_srvs::Trigger"/>
    <dynParameter name="gain" type="double" value="1"/>
  </node>
  <node name="watch" frequency="1">
    <serviceServer name="load" type="std_srvs::Trigger"/>
  </node>
</package>
"""
EDITS = {
    '"""Compute the outputs of one cycle from the latest inputs."""': (
        "data.out_pose.data = config.gain * data.in_goal.data"
    ),
    '"""Handle a message when it arrives, in a thread of its own."""': (
        "self.passthrough.log.info('stop')"
    ),
}

# Its logic in short: as the old model makes it, as the new one does, and as the developer has it.
PATH = "arm/reach_impl.py"
OLD = '''class ReachImpl:
    def serve_load(self, request, response):
        """Fill in the response and return it."""
        return response

    def serve_store(self, request, response):
        """Fill in the response and return it."""
        return response
'''
NEW = OLD.replace("Fill in", "Complete")
MINE = OLD.replace("return response", "response.ok = True\n        return response", 1)
