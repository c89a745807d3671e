// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial

/* global THREE, distanceToSeeAll, normalized */
/* exported ViewCamera */

// From where the surface is seen, and how that is changed by mouse, touch and keys.
class ViewCamera {
  // `onChange` is called when the view has changed.
  constructor(canvas, positions, pose, onChange) {
    this.positions = positions;
    this.pose = pose;
    this.camera = new THREE.PerspectiveCamera(32, 1, 0.01 * pose.size, 20 * pose.size);
    this.camera.up.set(...pose.up);
    this.controls = new THREE.OrbitControls(this.camera, canvas);
    this.controls.enableKeys = false;
    this.controls.screenSpacePanning = true;
    this.controls.minDistance = 0.05 * pose.size;
    this.controls.maxDistance = 8 * pose.size;
    this.controls.addEventListener("change", () => {
      this.isMoved = true;
      onChange();
    });
    this.reset();
  }

  dispose() {
    this.controls.dispose();
  }

  // Shows a part of the surface, from the side to which its normal points, where all of it is not too small to see.
  showPart(center, size, normal) {
    const distance = 4 * Math.max(size, 0.05 * this.pose.size) / Math.tan(this.camera.fov * Math.PI / 360) / 2;
    const fromCamera = normalized(this.camera.position.clone().sub(this.controls.target).toArray());
    // Not from straight above or below, where which way is up does not show.
    const direction = normal.map((x, i) => x + 0.4 * fromCamera[i]);
    this.controls.target.set(...center);
    this.camera.position.set(...normalized(direction).map((x, i) => center[i] + distance * x));
    this.controls.update();
  }

  // Shows all, from the front.
  reset() {
    const distance = distanceToSeeAll(this.positions, this.pose, this.camera.fov, this.camera.aspect);
    this.controls.target.set(0, 0, 0);
    this.camera.position.set(...this.pose.towardsEye.map(x => distance * x));
    this.controls.update();
    this.isMoved = false;
  }

  // A view that nobody has moved keeps showing all.
  setAspect(aspect) {
    const wasNarrow = Math.min(1, this.camera.aspect);
    this.camera.aspect = aspect;
    this.camera.updateProjectionMatrix();
    if (this.isMoved)
      this.zoom(Math.min(1, aspect) / wasNarrow);
    else
      this.reset();
  }

  // Turns the view to the right and upwards, by angles.
  turn(right, upwards) {
    const offset = this.camera.position.clone().sub(this.controls.target);
    offset.applyAxisAngle(this.camera.up, -right);
    const axis = new THREE.Vector3().crossVectors(this.camera.up, offset).normalize();
    const angle = offset.angleTo(this.camera.up);
    offset.applyAxisAngle(axis, Math.min(Math.max(angle - upwards, 0.02), Math.PI - 0.02) - angle);
    this.camera.position.copy(this.controls.target).add(offset);
    this.controls.update();
  }

  zoom(factor) {
    const offset = this.camera.position.clone().sub(this.controls.target);
    const {minDistance, maxDistance} = this.controls;
    offset.setLength(Math.min(Math.max(offset.length() / factor, minDistance), maxDistance));
    this.camera.position.copy(this.controls.target).add(offset);
    this.controls.update();
  }

  // Moves the view by fractions of what is seen.
  move(right, upwards) {
    const reach = 0.5 * this.camera.position.distanceTo(this.controls.target);
    const step = new THREE.Vector3().setFromMatrixColumn(this.camera.matrix, 0).multiplyScalar(right * reach);
    step.add(new THREE.Vector3().setFromMatrixColumn(this.camera.matrix, 1).multiplyScalar(upwards * reach));
    this.camera.position.add(step);
    this.controls.target.add(step);
    this.controls.update();
  }

  // Where a point is, on a picture of this width and height.
  project(point, width, height) {
    const projected = new THREE.Vector3(...point).project(this.camera);
    return [(projected.x + 1) / 2 * width, (1 - projected.y) / 2 * height];
  }
}
