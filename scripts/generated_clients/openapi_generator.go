// Runs the Go client of openapi-generator over every example.
package main

import (
	"bytes"
	"client"
	"context"
	"encoding/json"
	"errors"
	"fmt"
	"io"
	"os"
	"path/filepath"
	"reflect"
)

const patience = "wait=60"

var (
	background = context.Background()
	api        *client.APIClient
)

// read fills a body with a request, and fails if the client would send another request.
func read(request []byte, body interface{}) error {
	if err := json.Unmarshal(request, body); err != nil {
		return err
	}
	written, err := json.Marshal(body)
	if err != nil {
		return err
	}
	var sent, given interface{}
	if err := json.Unmarshal(written, &sent); err != nil {
		return err
	}
	if err := json.Unmarshal(request, &given); err != nil {
		return err
	}
	if !reflect.DeepEqual(withoutNulls(sent), withoutNulls(given)) {
		return fmt.Errorf("the request changes on its way through the client: %s", written)
	}
	return nil
}

// withoutNulls returns a value without the members that are null.
func withoutNulls(value interface{}) interface{} {
	switch value := value.(type) {
	case map[string]interface{}:
		for name, part := range value {
			if part == nil {
				delete(value, name)
			} else {
				value[name] = withoutNulls(part)
			}
		}
	case []interface{}:
		for k, part := range value {
			value[k] = withoutNulls(part)
		}
	}
	return value
}

// post creates the job of a request and returns its identifier.
func post(kind string, request []byte) (string, error) {
	switch kind {
	case "ruled_surface":
		var body client.RuledSurfaceRequest
		if err := read(request, &body); err != nil {
			return "", err
		}
		job, _, err := api.SolveAPI.PostRuledSurface(background).RuledSurfaceRequest(body).Prefer(patience).Execute()
		return job.GetId(), err
	case "minimal_surface":
		var body client.MinimalSurfaceRequest
		if err := read(request, &body); err != nil {
			return "", err
		}
		job, _, err := api.SolveAPI.PostMinimalSurface(background).MinimalSurfaceRequest(body).Prefer(patience).Execute()
		return job.GetId(), err
	case "uniform_mesh":
		var body client.UniformMeshRequest
		if err := read(request, &body); err != nil {
			return "", err
		}
		job, _, err := api.SolveAPI.PostUniformMesh(background).UniformMeshRequest(body).Prefer(patience).Execute()
		return job.GetId(), err
	case "tensile_structure":
		var body client.TensileStructureRequest
		if err := read(request, &body); err != nil {
			return "", err
		}
		job, _, err := api.SolveAPI.PostTensileStructure(background).TensileStructureRequest(body).Prefer(patience).Execute()
		return job.GetId(), err
	case "cable_net":
		var body client.CableNetRequest
		if err := read(request, &body); err != nil {
			return "", err
		}
		job, _, err := api.SolveAPI.PostCableNet(background).CableNetRequest(body).Prefer(patience).Execute()
		return job.GetId(), err
	}
	return "", fmt.Errorf("unknown kind %s", kind)
}

// figures returns the objective of a job that has succeeded, and whether its mesh has what its kind promises.
func figures(job *client.Job) (objective string, isGood bool) {
	switch job := job.GetActualInstance().(type) {
	case *client.RuledSurfaceJob:
		if it := job.Statistics.Get(); it != nil {
			return fmt.Sprint(it.Objective), it.Triangles > 0
		}
	case *client.MinimalSurfaceJob:
		if it := job.Statistics.Get(); it != nil {
			return fmt.Sprint(it.Objective), it.Triangles > 0 && it.Area > 0
		}
	case *client.UniformMeshJob:
		if it := job.Statistics.Get(); it != nil {
			return fmt.Sprint(it.Objective), it.Triangles > 0 && it.Nodes > 0
		}
	case *client.TensileStructureJob:
		if it := job.Statistics.Get(); it != nil {
			return fmt.Sprint(it.Objective), it.Triangles > 0
		}
	case *client.CableNetJob:
		if it := job.Statistics.Get(); it != nil {
			return fmt.Sprint(it.Objective), it.Edges > 0
		}
	}
	return "", false
}

func solve(request []byte) error {
	var named struct{ Kind string }
	if err := json.Unmarshal(request, &named); err != nil {
		return err
	}
	id, err := post(named.Kind, request)
	if err != nil {
		return err
	}
	var job *client.Job
	for status := client.Status("queued"); status == "queued" || status == "running"; {
		if job, _, err = api.JobsAPI.GetJob(background, id).Prefer(patience).Execute(); err != nil {
			return err
		}
		status = job.GetActualInstance().(interface{ GetStatus() client.Status }).GetStatus()
	}
	if objective, isGood := figures(job); !isGood || objective == "" {
		written, _ := json.Marshal(job)
		return fmt.Errorf("%s", written)
	}
	file, _, err := api.JobsAPI.GetMesh(background, id).Format("glb").Execute()
	if err != nil {
		return err
	}
	defer os.Remove(file.Name())
	mesh, err := io.ReadAll(file)
	if err == nil && !bytes.HasPrefix(mesh, []byte("glTF")) {
		err = errors.New("the mesh is no GLB")
	}
	return err
}

func main() {
	configuration := client.NewConfiguration()
	configuration.Servers[0].URL = os.Getenv("PLATEAU_URL")
	api = client.NewAPIClient(configuration)
	paths, _ := filepath.Glob(os.Args[1] + "/*.json")
	good := 0
	for _, path := range paths {
		request, err := os.ReadFile(path)
		if err == nil {
			err = solve(request)
		}
		if err == nil {
			good++
			continue
		}
		var answer *client.GenericOpenAPIError
		detail := err.Error()
		if errors.As(err, &answer) {
			detail += " " + string(answer.Body())
		}
		fmt.Fprintf(os.Stderr, "openapi-generator, go: %s: %.600s\n", filepath.Base(path), detail)
	}
	fmt.Printf("openapi-generator, go: %d of %d examples\n", good, len(paths))
	if good < len(paths) || good == 0 {
		os.Exit(1)
	}
}
