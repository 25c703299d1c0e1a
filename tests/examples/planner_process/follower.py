#!/usr/bin/env python3
"""A planner as a process of its own: follows the plan on arcs (pure pursuit, Coulter 1992), slower behind people and before them.
follower.cpp is the same in C++. All that has one stamp is of one control cycle; the answer is a velocity with that stamp."""
import math

from ros_dds import Domain

SPEED, LOOKAHEAD = 0.7, 1.2  # [m/s], [m]
TURN_RATE, BRAKING = 1.0, 0.5  # [rad/s], [m/s^2]
HALF_WIDTH, GAP = 0.5, 0.5  # of the robot with room beside it, and kept before people [m]
TWIST = "geometry_msgs/msg/TwistStamped"


def pose_of(odometry):
    position, turn = odometry.pose.pose.position, odometry.pose.pose.orientation
    return position.x, position.y, 2.0 * math.atan2(turn.z, turn.w)


def points_of(path):
    return [(pose.pose.position.x, pose.pose.position.y) for pose in path.poses]


def people_of(tracks):
    return [(t.position.x, t.position.y, t.velocity.x, t.velocity.y, t.radius) for t in tracks.tracks if t.confidence >= 0.5]


TOPICS = {"/odom": ("nav_msgs/msg/Odometry", pose_of), "/plan": ("nav_msgs/msg/Path", points_of),
          "/tracks": ("bandwagon_msgs/msg/Tracks", people_of)}


def rotated(x, y, angle):
    return x * math.cos(angle) - y * math.sin(angle), x * math.sin(angle) + y * math.cos(angle)


def speed_for(gap):
    """From which braking ends within the gap."""
    return math.sqrt(2.0 * BRAKING * max(gap, 0.0))


def velocity(pose, plan, people):
    """Speed [m/s] and turn rate [rad/s] of a robot at `pose` (x, y, heading); everything in one frame."""
    x, y, heading = pose
    aim = next((p for p in plan if math.dist(p, (x, y)) > LOOKAHEAD), plan[-1])
    ahead, beside = rotated(aim[0] - x, aim[1] - y, -heading)
    if ahead <= 0.0:
        return 0.0, math.copysign(TURN_RATE, beside)
    # The arc from the robot's heading through a point of its frame.
    curvature = 2.0 * beside / (ahead * ahead + beside * beside)
    speed = min(SPEED, TURN_RATE / max(abs(curvature), 1e-6), speed_for(math.dist(plan[-1], (x, y))))
    for px, py, vx, vy, radius in people:
        ahead, beside = rotated(px - x, py - y, -heading)
        approach, _ = rotated(vx, vy, -heading)
        if ahead > 0.0 and abs(beside) < HALF_WIDTH + radius:
            speed = min(speed, speed_for(ahead - radius - HALF_WIDTH - GAP + min(approach, 0.0)))  # in a second
    return speed, speed * curvature


def main():
    stamps, values, answered = dict.fromkeys(TOPICS), {}, None
    with Domain([TWIST, *(kind for kind, _ in TOPICS.values())]) as domain:
        readers = {topic: domain.reader(topic, kind) for topic, (kind, _) in TOPICS.items()}
        publish = domain.writer("/cmd_vel", TWIST)
        while True:
            domain.wait(1.0)
            for topic, reader in readers.items():
                for message in reader.take():
                    stamps[topic] = message.header.stamp.sec, message.header.stamp.nanosec
                    values[topic] = TOPICS[topic][1](message)
            now = stamps["/odom"]
            if now == answered or set(stamps.values()) != {now}:
                continue
            answer = domain.structures[TWIST]()
            answer.header.frame_id = b"base_link"
            answer.header.stamp.sec, answer.header.stamp.nanosec = answered = now
            answer.twist.linear.x, answer.twist.angular.z = velocity(*(values[topic] for topic in TOPICS))
            publish(answer)


if __name__ == "__main__":
    main()
