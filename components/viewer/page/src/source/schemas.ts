// ros2msg texts of what the page publishes; a topic that nobody publishes yet brings none with it.

const HEADER = "std_msgs/Header header\n";
const POSE = "geometry_msgs/Point position\ngeometry_msgs/Quaternion orientation\n";
const TWIST = "geometry_msgs/Vector3 linear\ngeometry_msgs/Vector3 angular\n";

const PARTS: Record<string, string> = {
  "std_msgs/Header": "builtin_interfaces/Time stamp\nstring frame_id\n",
  "builtin_interfaces/Time": "int32 sec\nuint32 nanosec\n",
  "geometry_msgs/Point": "float64 x\nfloat64 y\nfloat64 z\n",
  "geometry_msgs/Vector3": "float64 x\nfloat64 y\nfloat64 z\n",
  "geometry_msgs/Quaternion": "float64 x\nfloat64 y\nfloat64 z\nfloat64 w\n",
  "geometry_msgs/Pose": POSE,
  "geometry_msgs/PoseWithCovariance": "geometry_msgs/Pose pose\nfloat64[36] covariance\n",
  "geometry_msgs/Twist": TWIST,
};

const ROOTS: Record<string, string> = {
  "geometry_msgs/msg/PoseStamped": HEADER + "geometry_msgs/Pose pose\n",
  "geometry_msgs/msg/PoseWithCovarianceStamped": HEADER + "geometry_msgs/PoseWithCovariance pose\n",
  "geometry_msgs/msg/PointStamped": HEADER + "geometry_msgs/Point point\n",
  "geometry_msgs/msg/Twist": TWIST,
  "geometry_msgs/msg/TwistStamped": HEADER + "geometry_msgs/Twist twist\n",
  "std_msgs/msg/Empty": "",
  "std_msgs/msg/String": "string data\n",
  "std_msgs/msg/Bool": "bool data\n",
  "std_msgs/msg/Float64": "float64 data\n",
};

/** Undefined for a type that the page does not know by itself. */
export function knownSchema(type: string): string | undefined {
  const root = ROOTS[type];
  if (root === undefined) return undefined;
  const parts = Object.entries(PARTS).map(([name, text]) => `${"=".repeat(80)}\nMSG: ${name}\n${text}`);
  return [root, ...(root ? parts : [])].join("");
}
