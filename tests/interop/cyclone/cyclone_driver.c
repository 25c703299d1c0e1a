// Drives a robot of ours 0.5 m straight on, over another vendor's DDS, and prints what it saw as `key: value`
// lines. Every wait is bounded; exit status 0 when all of it was seen.
//   ROS_DOMAIN_ID=81 cyclone_driver
#include <math.h>
#include <stdbool.h>
#include <string.h>

#include "cyclone_common.h"
#include "geometry_msgs/msg/Twist.h"
#include "nav_msgs/msg/OccupancyGrid.h"
#include "nav_msgs/msg/Odometry.h"
#include "sensor_msgs/msg/LaserScan.h"

static const double kSpeed = 0.4;     // [m/s]
static const double kDistance = 0.5;  // [m]
static const dds_duration_t kPeriod = DDS_MSECS(50);

static dds_qos_t* reliable(dds_durability_kind_t durability) {
  dds_qos_t* qos = dds_create_qos();
  dds_qset_reliability(qos, DDS_RELIABILITY_RELIABLE, DDS_MSECS(100));
  dds_qset_durability(qos, durability);
  dds_qset_history(qos, DDS_HISTORY_KEEP_LAST, 1);
  return qos;
}

static dds_entity_t reader_of(dds_entity_t participant, dds_entity_t topic,
                              dds_durability_kind_t durability) {
  dds_qos_t* qos = reliable(durability);
  const dds_entity_t reader = checked(dds_create_reader(participant, topic, qos, NULL), "reader");
  dds_delete_qos(qos);
  return reader;
}

// The newest sample into `sample`; false when none came within `limit`.
static bool take_within(dds_entity_t reader, void* sample, dds_duration_t limit) {
  const dds_time_t end = dds_time() + limit;
  do {
    dds_sample_info_t info;
    void* samples[1] = {sample};
    if (dds_take(reader, samples, &info, 1, 1) > 0 && info.valid_data) return true;
    dds_sleepfor(DDS_MSECS(5));
  } while (dds_time() < end);
  return false;
}

static void require(bool seen, const char* what) {
  if (seen) return;
  fprintf(stderr, "nothing seen of: %s\n", what);
  exit(1);
}

// Who announced itself, with the user data that ROS 2's tools look at.
static void print_participants(dds_entity_t participant) {
  const dds_entity_t reader =
      checked(dds_create_reader(participant, DDS_BUILTIN_TOPIC_DCPSPARTICIPANT, NULL, NULL), "participants");
  dds_sample_info_t infos[16];
  void* samples[16] = {NULL};
  const dds_return_t count = dds_take(reader, samples, infos, 16, 16);
  for (dds_return_t i = 0; i < count; ++i) {
    const dds_builtintopic_participant_t* seen = samples[i];
    void* data = NULL;
    size_t size = 0;
    char* name = NULL;
    dds_qget_userdata(seen->qos, &data, &size);
    dds_qget_entity_name(seen->qos, &name);
    if (size > 0) printf("participant: %s %.*s\n", name ? name : "-", (int)size, (const char*)data);
    dds_free(data);
    dds_free(name);
  }
  if (count > 0) dds_return_loan(reader, samples, count);
}

static void command(dds_entity_t writer, double speed) {
  geometry_msgs_msg_Twist twist;
  memset(&twist, 0, sizeof(twist));
  twist.linear.x = speed;
  checked(dds_write(writer, &twist), "write");
}

int main(void) {
  const dds_entity_t participant = join_domain();

  const dds_entity_t odom = reader_of(
      participant,
      ros_topic(participant, &nav_msgs_msg_Odometry_desc, "nav_msgs::msg::dds_::Odometry_", "rt/odom"),
      DDS_DURABILITY_VOLATILE);
  const dds_entity_t scan = reader_of(participant,
                                      ros_topic(participant, &sensor_msgs_msg_LaserScan_desc,
                                                "sensor_msgs::msg::dds_::LaserScan_", "rt/scan"),
                                      DDS_DURABILITY_VOLATILE);
  const dds_entity_t map = reader_of(participant,
                                     ros_topic(participant, &nav_msgs_msg_OccupancyGrid_desc,
                                               "nav_msgs::msg::dds_::OccupancyGrid_", "rt/map"),
                                     DDS_DURABILITY_TRANSIENT_LOCAL);
  dds_qos_t* qos = reliable(DDS_DURABILITY_VOLATILE);
  const dds_entity_t cmd_vel =
      checked(dds_create_writer(participant,
                                ros_topic(participant, &geometry_msgs_msg_Twist_desc,
                                          "geometry_msgs::msg::dds_::Twist_", "rt/cmd_vel"),
                                qos, NULL),
              "writer");
  dds_delete_qos(qos);

  nav_msgs_msg_Odometry* here = nav_msgs_msg_Odometry__alloc();
  require(take_within(odom, here, DDS_SECS(30)), "rt/odom");
  print_participants(participant);
  printf("odometry: %s to %s\n", here->header.frame_id, here->child_frame_id);
  const double start = here->pose.pose.position.x;

  sensor_msgs_msg_LaserScan* beams = sensor_msgs_msg_LaserScan__alloc();
  require(take_within(scan, beams, DDS_SECS(20)), "rt/scan");
  printf("scan: %u ranges, %.2f m ahead\n", beams->ranges._length,
         (double)beams->ranges._buffer[beams->ranges._length / 2]);

  // The map was published once, before we came.
  nav_msgs_msg_OccupancyGrid* grid = nav_msgs_msg_OccupancyGrid__alloc();
  require(take_within(map, grid, DDS_SECS(20)), "rt/map");
  uint32_t occupied = 0;
  for (uint32_t i = 0; i < grid->data._length; ++i) occupied += grid->data._buffer[i] == 100;
  printf("map: %u x %u cells, %u bytes, %s\n", grid->info.width, grid->info.height, grid->data._length,
         occupied > 0 ? "with walls" : "empty");

  double moved = 0.0;
  for (const dds_time_t end = dds_time() + DDS_SECS(20); moved < kDistance && dds_time() < end;) {
    command(cmd_vel, kSpeed);
    if (take_within(odom, here, kPeriod)) moved = here->pose.pose.position.x - start;
    dds_sleepfor(kPeriod);
  }
  printf("moved: %.3f m\n", moved);
  require(moved >= kDistance, "motion after rt/cmd_vel");

  double speed = kSpeed;
  for (const dds_time_t end = dds_time() + DDS_SECS(10); fabs(speed) > 0.01 && dds_time() < end;) {
    command(cmd_vel, 0.0);
    if (take_within(odom, here, kPeriod)) speed = here->twist.twist.linear.x;
  }
  printf("speed at the end: %.3f m/s\n", fabs(speed));
  require(fabs(speed) <= 0.01, "a stop after rt/cmd_vel");

  nav_msgs_msg_Odometry_free(here, DDS_FREE_ALL);
  sensor_msgs_msg_LaserScan_free(beams, DDS_FREE_ALL);
  nav_msgs_msg_OccupancyGrid_free(grid, DDS_FREE_ALL);
  dds_delete(DDS_CYCLONEDDS_HANDLE);
  return 0;
}
