// A Vulkan layer: the driver below it works, until a file says that it does not. Then it answers as the
// specification has a driver answer that has lost its device, or its surface.
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include <vulkan/vk_layer.h>
#include <vulkan/vulkan.h>

static PFN_vkGetInstanceProcAddr next_of_instance;
static PFN_vkGetDeviceProcAddr next_of_device;
static VkInstance the_instance;
static VkDevice the_device;

static int is_lost(const char *what) {
  const char *path = getenv(what);
  return path && access(path, F_OK) == 0;
}

// A function of the device that fails if the file is there.
#define FAILING(when, error, name, parameters, arguments)                     \
  static VKAPI_ATTR VkResult VKAPI_CALL name parameters {                     \
    if (is_lost(when)) return error;                                          \
    return ((PFN_vk##name)next_of_device(the_device, "vk" #name)) arguments;  \
  }
#define ON_DEVICE(...) FAILING("LOST_DEVICE", VK_ERROR_DEVICE_LOST, __VA_ARGS__)
#define ON_SURFACE(...) FAILING("LOST_SURFACE", VK_ERROR_SURFACE_LOST_KHR, __VA_ARGS__)
ON_DEVICE(QueueSubmit, (VkQueue q, uint32_t n, const VkSubmitInfo *s, VkFence f), (q, n, s, f))
ON_DEVICE(QueueWaitIdle, (VkQueue q), (q))
ON_DEVICE(QueuePresentKHR, (VkQueue q, const VkPresentInfoKHR *p), (q, p))
ON_DEVICE(DeviceWaitIdle, (VkDevice d), (d))
ON_DEVICE(WaitForFences, (VkDevice d, uint32_t n, const VkFence *f, VkBool32 all, uint64_t t), (d, n, f, all, t))
ON_DEVICE(WaitSemaphores, (VkDevice d, const VkSemaphoreWaitInfo *w, uint64_t t), (d, w, t))
ON_DEVICE(GetSemaphoreCounterValue, (VkDevice d, VkSemaphore s, uint64_t *v), (d, s, v))
ON_SURFACE(AcquireNextImageKHR,
  (VkDevice d, VkSwapchainKHR s, uint64_t t, VkSemaphore semaphore, VkFence f, uint32_t *image),
  (d, s, t, semaphore, f, image))
ON_SURFACE(CreateSwapchainKHR,
  (VkDevice d, const VkSwapchainCreateInfoKHR *info, const VkAllocationCallbacks *a, VkSwapchainKHR *s),
  (d, info, a, s))

static VKAPI_ATTR VkResult VKAPI_CALL CreateInstance(
    const VkInstanceCreateInfo *info, const VkAllocationCallbacks *a, VkInstance *instance) {
  VkLayerInstanceCreateInfo *link = (VkLayerInstanceCreateInfo *)info->pNext;
  while (link->sType != VK_STRUCTURE_TYPE_LOADER_INSTANCE_CREATE_INFO || link->function != VK_LAYER_LINK_INFO)
    link = (VkLayerInstanceCreateInfo *)link->pNext;
  next_of_instance = link->u.pLayerInfo->pfnNextGetInstanceProcAddr;
  link->u.pLayerInfo = link->u.pLayerInfo->pNext;
  VkResult result = ((PFN_vkCreateInstance)next_of_instance(NULL, "vkCreateInstance"))(info, a, instance);
  the_instance = *instance;
  return result;
}

static VKAPI_ATTR VkResult VKAPI_CALL CreateDevice(
    VkPhysicalDevice p, const VkDeviceCreateInfo *info, const VkAllocationCallbacks *a, VkDevice *device) {
  VkLayerDeviceCreateInfo *link = (VkLayerDeviceCreateInfo *)info->pNext;
  while (link->sType != VK_STRUCTURE_TYPE_LOADER_DEVICE_CREATE_INFO || link->function != VK_LAYER_LINK_INFO)
    link = (VkLayerDeviceCreateInfo *)link->pNext;
  next_of_device = link->u.pLayerInfo->pfnNextGetDeviceProcAddr;
  link->u.pLayerInfo = link->u.pLayerInfo->pNext;
  VkResult result = ((PFN_vkCreateDevice)next_of_instance(the_instance, "vkCreateDevice"))(p, info, a, device);
  the_device = *device;
  return result;
}

static PFN_vkVoidFunction own(const char *name) {
#define OWN(own) if (!strcmp(name, "vk" #own)) return (PFN_vkVoidFunction)own;
  OWN(CreateInstance) OWN(CreateDevice) OWN(QueueSubmit) OWN(QueueWaitIdle) OWN(QueuePresentKHR)
  OWN(DeviceWaitIdle) OWN(WaitForFences) OWN(WaitSemaphores) OWN(GetSemaphoreCounterValue)
  OWN(AcquireNextImageKHR) OWN(CreateSwapchainKHR)
  return NULL;
}

VKAPI_ATTR PFN_vkVoidFunction VKAPI_CALL function_of_device(VkDevice device, const char *name) {
  if (!strcmp(name, "vkGetDeviceProcAddr")) return (PFN_vkVoidFunction)function_of_device;
  PFN_vkVoidFunction function = own(name);
  // What the driver does not have, the layer does not have either.
  PFN_vkVoidFunction below = next_of_device(device, name);
  return function && below ? function : below;
}

VKAPI_ATTR PFN_vkVoidFunction VKAPI_CALL function_of_instance(VkInstance instance, const char *name) {
  if (!strcmp(name, "vkGetInstanceProcAddr")) return (PFN_vkVoidFunction)function_of_instance;
  if (!strcmp(name, "vkGetDeviceProcAddr")) return (PFN_vkVoidFunction)function_of_device;
  PFN_vkVoidFunction function = own(name);
  return function || !next_of_instance ? function : next_of_instance(instance, name);
}
