"""Starts a simulated dog and robot_state_publisher on this machine.

    ros2 launch aibo.launch.py [rmw:=rmw_cyclonedds_cpp|rmw_fastrtps_cpp] [domain:=0] [model:=ers210]

`openr` must be in PATH.  The topics are those of docs/ros2.md.
"""
import subprocess

from launch import LaunchDescription
from launch.actions import (DeclareLaunchArgument, ExecuteProcess, OpaqueFunction,
                            SetEnvironmentVariable)
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node

# Cyclone DDS finds the run without multicast, on this machine alone.
CYCLONE = """<CycloneDDS><Domain id="any">
  <General><Interfaces><NetworkInterface address="127.0.0.1"/></Interfaces>
    <AllowMulticast>false</AllowMulticast></General>
  <Discovery><ParticipantIndex>auto</ParticipantIndex>
    <MaxAutoParticipantIndex>120</MaxAutoParticipantIndex>
    <Peers><Peer address="127.0.0.1"/></Peers></Discovery>
</Domain></CycloneDDS>"""

# The run answers the multicast by which Fast DDS looks for others; data goes to each reader alone.
ANSWER_MULTICAST = """<CycloneDDS><Domain id="any">
  <General><AllowMulticast>spdp</AllowMulticast></General></Domain></CycloneDDS>"""


def start(context):
    value = lambda name: LaunchConfiguration(name).perform(context)
    run = ["openr", "run", "--ros2", "--robot", value("model"), "--dds-domain", value("domain")]
    actions = [SetEnvironmentVariable("RMW_IMPLEMENTATION", value("rmw")),
               SetEnvironmentVariable("ROS_DOMAIN_ID", value("domain"))]
    if value("rmw") == "rmw_cyclonedds_cpp":
        actions.append(SetEnvironmentVariable("CYCLONEDDS_URI", CYCLONE))
    else:
        with open("openr-dds.xml", "w") as file:
            file.write(ANSWER_MULTICAST)
        run += ["--dds-config", "openr-dds.xml"]
    description = subprocess.run(["openr", "model", "urdf", value("model")], check=True,
                                 capture_output=True, text=True).stdout
    return actions + [
        ExecuteProcess(cmd=run, output="screen"),
        Node(package="robot_state_publisher", executable="robot_state_publisher",
             namespace="aibo",
             parameters=[{"robot_description": description, "frame_prefix": "aibo/",
                          "use_sim_time": True}])]


def generate_launch_description():
    return LaunchDescription([
        DeclareLaunchArgument("rmw", default_value="rmw_cyclonedds_cpp"),
        DeclareLaunchArgument("domain", default_value="0"),
        DeclareLaunchArgument("model", default_value="ers210"),
        OpaqueFunction(function=start)])
