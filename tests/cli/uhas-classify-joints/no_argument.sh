uhas-classify-joints
